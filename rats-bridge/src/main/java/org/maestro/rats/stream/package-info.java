/**
 * Streams of pictures and sound from the receiver's side: a call begins one, its frames flow in
 * with the time at which they were captured, what is missing is told, and the call's end ends it.
 * Streams can be recorded to files and played again. It knows neither what frames show nor who
 * looks at them.
 */
@NullMarked
package org.maestro.rats.stream;

import org.jspecify.annotations.NullMarked;
