/**
 * JADE containers as MAESTRO makes and ends them: safe profiles, ports, directories, and who lives
 * where. Settings flow in; running containers, or one sentence why there is none, flow out. It
 * knows no goal.
 */
@NullMarked
package org.maestro.platform.jade;

import org.jspecify.annotations.NullMarked;
