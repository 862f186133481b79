/**
 * What agents of a container run on. The many that stand for devices get threads that cost next to
 * nothing where Java has such, all others one of the system's each, as everywhere in JADE. The kind
 * of thread that JADE asks for and what is to run on it flow in, a thread flows out. It may not
 * know what agents do.
 */
@NullMarked
package org.maestro.platform.threads;

import org.jspecify.annotations.NullMarked;
