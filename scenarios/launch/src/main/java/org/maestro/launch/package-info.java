/**
 * The command line: each command a small class, {@link org.maestro.launch.Maestro} the door to
 * them. What people type flows in; sentences on the terminal, or one JSON document, and an exit
 * code flow out. It is the only package, with tests, experiments and benchmarks, that sees all
 * layers; no other package may know it.
 */
@NullMarked
package org.maestro.launch;

import org.jspecify.annotations.NullMarked;
