/**
 * A goal that is held until it is cancelled (Three-layered architecture, 1 and 5.1; M5, M91):
 * observed, brought about again when it is lost, and held by cheaper settings. Each bringing about
 * is a goal of its own, made by whoever opens it. It does not know how that one is reached.
 */
@NullMarked
package org.maestro.coordination.maintenance;

import org.jspecify.annotations.NullMarked;
