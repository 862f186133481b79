package org.maestro.language.lexicon;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Wording;

/**
 * Whether what somebody is to be told, or what is to be noted, may end with its last word: nobody
 * notes "milk and", and who has dinner told to be in ten minutes does not have it told then.
 * Immutable.
 */
public final class WholeTexts implements Predicate<Form> {
  private final Set<String> unfinished;

  /** Constructions, and their roles that go on to the end. */
  private final Map<String, Set<String>> toTheEnd = new HashMap<>();

  public WholeTexts(Grammar grammar, Wording wording) {
    this.unfinished =
        grammar.list("unfinished").stream()
            .map(words -> String.join(" ", words))
            .collect(Collectors.toSet());
    for (Construction construction : wording.constructions()) {
      toTheEnd.put(
          construction.name(),
          construction.roles().stream()
              .filter(Construction.Role::toTheEnd)
              .map(Construction.Role::name)
              .collect(Collectors.toSet()));
    }
  }

  @Override
  public boolean test(Form form) {
    if (form.is("act-timed")) {
      return !endsInText(form.part(0));
    }
    return !form.is("frame")
        || form.parts().stream()
            .filter(part -> part.is("role"))
            .noneMatch(role -> unfinished.contains(lastWord(role.part(1))));
  }

  private boolean endsInText(Form act) {
    List<Form> parts = act.parts();
    if (!act.is("frame")) {
      return !parts.isEmpty() && endsInText(parts.get(parts.size() - 1));
    }
    Set<String> texts = toTheEnd.getOrDefault(act.text(0), Set.of());
    return parts.stream()
        .anyMatch(
            part ->
                part.is("role") && texts.contains(part.text(0)) && !part.part(1).equals(Form.HOLE));
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
