/**
 * MAESTRO-SL, the one language for goals, conditions, effects, questions and answers: its syntax
 * tree, parser, printer and evaluation over a {@link org.maestro.sl.Facts} interface. Text flows
 * in, trees flow out, and the printer is the parser's inverse. It knows nothing of RDF, agents or
 * planning.
 */
@NullMarked
package org.maestro.sl;

import org.jspecify.annotations.NullMarked;
