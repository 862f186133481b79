/**
 * What the console costs who looks at it: a real platform with its page in a real Chromium. The
 * browser is driven by its own protocol for developers, so that nothing but the browser is needed.
 * Figures flow out; of the page only what a person sees of it is known.
 */
@NullMarked
package org.maestro.bench.console;

import org.jspecify.annotations.NullMarked;
