package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Form;

/** What is said of everything: of lamps and appliances alike, though each has its own words. */
final class Everything {
  private Everything() {}

  /** Whether everything is spoken of. */
  static boolean isSaidIn(Form form) {
    return form.is("everything") || form.parts().stream().anyMatch(Everything::isSaidIn);
  }

  /** One command for those of the best that are of everything; empty when there is one alone. */
  static Optional<Form> together(List<Meaning> meanings) {
    if (meanings.isEmpty()) {
      return Optional.empty();
    }
    Meaning best = meanings.get(0);
    List<Form> commands = new ArrayList<>();
    for (Meaning one : meanings) {
      boolean isAsGood = one.broken() == best.broken() && one.penalty() == best.penalty();
      if (isAsGood && one.form().is("do") && isSaidIn(one.form())) {
        commands.add(one.form().part(0));
      }
    }
    return commands.size() < 2
        ? Optional.empty()
        : commands.stream()
            .reduce((first, second) -> Form.of("both", first, second))
            .map(all -> Form.of("do", all));
  }
}
