/**
 * What the console has shown, to be looked at again: the events that pages are told flow in, dated
 * by the wall and by the platform's clock; what was so at a time, what happened, and what was
 * measured flow out. It is kept in memory up to a weight and an age, and in files where there is a
 * directory for them. It knows no server and no platform.
 */
@NullMarked
package org.maestro.console.history;

import org.jspecify.annotations.NullMarked;
