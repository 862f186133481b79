package org.maestro.coordination.scripts;

import java.util.List;
import java.util.function.BiConsumer;
import org.maestro.sl.Term;

/**
 * A question of a script to people.
 *
 * @param type see {@link org.maestro.sl.Body.Ask}
 * @param answered told once what the first answer that would do stands for, and whose it is
 */
record Question(String who, List<Term> words, String type, BiConsumer<Term, String> answered) {}
