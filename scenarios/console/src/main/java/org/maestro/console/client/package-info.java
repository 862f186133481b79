/**
 * The client of a console: questions go out by HTTP, and come back as documents. It is quick to
 * start, as commands want it, and loads nothing of the platform.
 */
@NullMarked
package org.maestro.console.client;

import org.jspecify.annotations.NullMarked;
