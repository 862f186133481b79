/**
 * Who may come in at the console, and as whom. What a request brings flows in, without the ways of
 * HTTP, and out flows a visit with its role, or why there is none. Of an open site everybody on the
 * machine may all; of a secured one the persons that its files name may what their role says.
 */
@NullMarked
package org.maestro.console.access;

import org.jspecify.annotations.NullMarked;
