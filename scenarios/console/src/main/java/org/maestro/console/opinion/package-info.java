/**
 * A second opinion on words that nobody here understands, from a language model behind an
 * OpenAI-compatible endpoint. What was said and what can be said flow out, proposals flow in; what
 * becomes of them is decided elsewhere. It knows no home and no goal.
 */
@NullMarked
package org.maestro.console.opinion;

import org.jspecify.annotations.NullMarked;
