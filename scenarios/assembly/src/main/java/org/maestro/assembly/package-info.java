/**
 * Puts a whole site together in one process: bus, simulated devices, link, knowledge and platform,
 * on one clock. A home, a scene and a few choices flow in, a running site flows out. It decides
 * nothing: command line, tests and experiments all start here.
 */
@NullMarked
package org.maestro.assembly;

import org.jspecify.annotations.NullMarked;
