/**
 * Memory with a bound: maps that forget their oldest entries. What others send may be without end,
 * what is remembered of it is not. It knows nothing of what it holds.
 */
@NullMarked
package org.maestro.rats.bounded;

import org.jspecify.annotations.NullMarked;
