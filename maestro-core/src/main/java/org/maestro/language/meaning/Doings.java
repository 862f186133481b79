package org.maestro.language.meaning;

import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.Situation;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * What is asked about what is being done, was asked for and can be done. Which goals that concerns
 * is known to who pursues them. Bound to one reading.
 */
final class Doings {
  private final Situation situation;
  private final References references;

  Doings(Situation situation, References references) {
    this.situation = situation;
    this.references = references;
  }

  Optional<Content> message(Form act) {
    return switch (act.head()) {
      case "doing", "done", "asked", "planned", "lasts" -> of("query-ref", act.head(), List.of());
      case "whodid" -> of("query-ref", "history", List.of());
      case "isdone" -> of("query-if", "done", List.of());
      case "again" -> of("initCNP", "last", List.of());
      case "able" -> able(act);
      default -> {
        references.die();
        yield Optional.empty();
      }
    };
  }

  private static Optional<Content> of(
      String operator, String name, List<Content.Argument> arguments) {
    return Optional.of(new Content(operator, List.of(new Content.Argument.Named(name, arguments))));
  }

  private Optional<Content> able(Form act) {
    if (act.parts().isEmpty() || act.part(0).is("everywhere")) {
      return of("query-ref", "able", List.of());
    }
    Optional<List<Term>> places =
        act.part(0).is("rel")
            ? references.terms(act.part(0).part(1), "")
            : situation.here().map(here -> List.of(new Term.Name(here)));
    return places
        .filter(all -> all.size() == 1)
        .flatMap(all -> of("query-ref", "able", List.of(new Content.Argument.OfTerm(all.get(0)))));
  }
}
