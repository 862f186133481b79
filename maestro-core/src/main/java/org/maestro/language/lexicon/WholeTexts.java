package org.maestro.language.lexicon;

import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;

/**
 * Whether what somebody is to be told, or what is to be noted, may end with its last word: nobody
 * notes "milk and". Immutable.
 */
public final class WholeTexts implements Predicate<Form> {
  private final Set<String> unfinished;

  public WholeTexts(Grammar grammar) {
    this.unfinished =
        grammar.list("unfinished").stream()
            .map(words -> String.join(" ", words))
            .collect(Collectors.toSet());
  }

  @Override
  public boolean test(Form form) {
    return !form.is("frame")
        || form.parts().stream()
            .filter(part -> part.is("role"))
            .noneMatch(role -> unfinished.contains(lastWord(role.part(1))));
  }

  /** The last of words as they are; "" of a phrase. */
  private static String lastWord(Form filler) {
    List<Form> parts = filler.parts();
    if (parts.isEmpty()) {
      return filler.head();
    }
    return filler.is("text") ? parts.get(parts.size() - 1).head() : "";
  }
}
