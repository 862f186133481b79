package org.maestro.ontology.wording;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * Words for a state in which something can be, such as "on". The formulas speak of {@code ?it}.
 *
 * @param name local name
 * @param of the class of what can be so
 * @param holdsWhen when it is so
 * @param broughtAboutBy the goal of who wishes it so; empty: nobody can have it so by wishing
 * @param foretells sentences that tell when {@code {it}} will be so, in {@code {span}}
 */
public record StateWord(
    String name,
    List<Said> says,
    String of,
    Formula holdsWhen,
    Optional<Formula> broughtAboutBy,
    List<Said> foretells) {
  public StateWord {
    foretells = List.copyOf(foretells);
    says = List.copyOf(says);
  }
}
