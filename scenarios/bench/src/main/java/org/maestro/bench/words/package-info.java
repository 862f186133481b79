/**
 * How well and how fast words are understood: with noise in them, in a home with many things and
 * titles, and beside an engine that matches whole sentences. Utterances flow in, figures flow out.
 * Knows the language and no platform.
 */
@NullMarked
package org.maestro.bench.words;

import org.jspecify.annotations.NullMarked;
