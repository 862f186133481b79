package org.maestro.coordination.scripts;

import java.util.List;
import java.util.function.Consumer;
import org.maestro.sl.Term;

/**
 * A question of a script to people.
 *
 * @param type see {@link org.maestro.sl.Body.Ask}
 * @param answered told once what the first answer that would do stands for
 */
record Question(String who, List<Term> words, String type, Consumer<Term> answered) {}
