/**
 * The parse of an utterance while it is heard: an Earley chart that grows by one column with each
 * word and can be cut back (RISE: ADE, 4.2). Words and a grammar flow in; readings flow out, those
 * of whole utterances and those of what was said so far, with a hole for what was not. Knows no
 * world and no language.
 */
@NullMarked
package org.maestro.language.chart;

import org.jspecify.annotations.NullMarked;
