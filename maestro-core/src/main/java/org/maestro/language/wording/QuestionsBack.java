package org.maestro.language.wording;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What is asked back, or said instead, when something stays in doubt. */
public final class QuestionsBack {
  private final Situation situation;
  private final Grammar grammar;
  private final Naming naming;

  public QuestionsBack(Situation situation, Grammar grammar) {
    this.situation = situation;
    this.grammar = grammar;
    this.naming = new Naming(situation.home(), grammar);
  }

  /** The sentence for a doubt. */
  public String of(Doubt doubt) {
    if (doubt instanceof Doubt.Which which) {
      return which(which);
    } else if (doubt instanceof Doubt.Missing missing) {
      return missing(missing);
    } else if (doubt instanceof Doubt.NoSuch none) {
      return Phrases.filled(grammar.phrase("none"), Map.of("what", said(none.said())));
    } else if (doubt instanceof Doubt.NotKnown unknown) {
      return Phrases.filled(
          grammar.phrase("not-known"),
          Map.of(
              "what", naming.word(unknown.fluent().name()),
              "whose",
                  unknown.fluent().arguments().stream()
                      .map(naming::of)
                      .collect(Collectors.joining(" "))));
    } else if (doubt instanceof Doubt.Confirm) {
      return grammar.phrase("confirm");
    }
    return grammar.phrase("not-possible");
  }

  /**
   * What is asked when readings are as good: which kind of thing is meant, where they differ so.
   */
  public String between(List<Meaning> meanings) {
    Set<Term.Name> common = new LinkedHashSet<>(meanings.get(0).mentioned());
    meanings.forEach(meaning -> common.retainAll(meaning.mentioned()));
    List<Term.Name> different =
        meanings.stream()
            .flatMap(
                meaning ->
                    meaning.mentioned().stream().filter(thing -> !common.contains(thing)).limit(1))
            .distinct()
            .toList();
    List<String> names = different.stream().map(naming::of).distinct().toList();
    return names.size() == 2
        ? Phrases.filled(
            grammar.phrase("which-name"), Map.of("first", names.get(0), "last", names.get(1)))
        : ofKinds(kinds(different));
  }

  private List<String> kinds(List<Term.Name> candidates) {
    return candidates.stream().map(naming::kind).flatMap(Optional::stream).distinct().toList();
  }

  private String ofKinds(List<String> kinds) {
    return kinds.size() == 2
        ? Phrases.filled(
            grammar.phrase("which-kind"), Map.of("first", kinds.get(0), "last", kinds.get(1)))
        : grammar.phrase("ambiguous");
  }

  private String missing(Doubt.Missing missing) {
    return missing.role().questions().stream()
        .filter(question -> question.isIn(grammar.language()))
        .map(Said::text)
        .map(text -> Phrases.filled(text, rolesOf(missing.construction())))
        .findFirst()
        .orElseGet(
            () -> Phrases.filled(grammar.phrase("missing"), Map.of("role", missing.role().name())));
  }

  private static Map<String, String> rolesOf(Construction construction) {
    return construction.roles().stream()
        .collect(Collectors.toMap(Construction.Role::name, role -> "it", (a, b) -> a));
  }

  private String which(Doubt.Which doubt) {
    List<Term.Name> candidates = doubt.candidates();
    String kind =
        noun(doubt.said())
            .or(() -> candidates.stream().findFirst().flatMap(naming::kind))
            .orElse("");
    List<String> names = candidates.stream().map(naming::of).distinct().toList();
    if (names.size() < candidates.size() && byPlace(candidates).isEmpty()) {
      List<String> kinds = kinds(candidates);
      return kinds.size() == 2
          ? ofKinds(kinds)
          : Phrases.filled(grammar.phrase("which-of-many"), Map.of("kind", kind));
    }
    List<String> choices =
        names.size() == candidates.size() ? names : byPlace(candidates).orElse(names);
    if (choices.size() > 4) {
      return Phrases.filled(grammar.phrase("which-of-many"), Map.of("kind", kind));
    }
    String last = choices.get(choices.size() - 1);
    String first = String.join(", ", choices.subList(0, choices.size() - 1));
    return Phrases.filled(
        grammar.phrase("which"), Map.of("kind", kind, "first", first, "last", last));
  }

  /** The class that was said. */
  private Optional<String> noun(Form said) {
    return said.is("noun")
        ? Optional.of(naming.bare(said.text(0)))
        : said.parts().stream().map(this::noun).flatMap(Optional::stream).findFirst();
  }

  /** Things by where they are, the one on the table, where that tells them apart. */
  private Optional<List<String>> byPlace(List<Term.Name> things) {
    for (Map.Entry<String, List<Said>> entry :
        situation.home().wording().prepositions().entrySet()) {
      Optional<String> word =
          entry.getValue().stream()
              .filter(said -> said.isIn(grammar.language()))
              .map(Said::text)
              .findFirst();
      Optional<PredicateDeclaration> predicate =
          situation.home().vocabulary().predicate(entry.getKey());
      if (word.isEmpty()
          || predicate.filter(one -> one.parameters().size() == 2 && !one.symmetric()).isEmpty()) {
        continue;
      }
      List<String> places =
          things.stream()
              .flatMap(thing -> place(predicate.get(), thing).stream())
              .distinct()
              .toList();
      if (places.size() == things.size()) {
        return Optional.of(
            places.stream()
                .map(
                    place ->
                        Phrases.filled(
                            grammar.phrase("one-at"),
                            Map.of("preposition", word.get(), "place", place)))
                .toList());
      }
    }
    return Optional.empty();
  }

  private Optional<String> place(PredicateDeclaration predicate, Term.Name thing) {
    return situation.facts().individuals(Relations.typeOf(predicate, 1)).stream()
        .filter(place -> !place.equals(thing))
        .filter(place -> holds(predicate.name(), thing, place))
        .findFirst()
        .map(naming::of);
  }

  private boolean holds(String predicate, Term thing, Term place) {
    return new Evaluation(situation.facts())
            .truth(new Formula.Atom(predicate, List.of(thing, place)), Map.of())
        == Truth.TRUE;
  }

  /** What was said, as far as it has names. */
  private String said(Form form) {
    return switch (form.head()) {
      case "noun", "name" -> naming.bare(form.text(0));
      case "np" -> said(form.part(form.parts().size() - 1));
      case "mod" -> form.part(0).text(1) + " " + said(form.part(1));
      case "at" -> said(form.part(0)) + " " + said(form.part(1));
      case "rel" -> grammar.phrase("there");
      case "it", "them", "him" -> grammar.phrase("it");
      case "beside", "of" -> said(form.part(0)) + " " + said(form.part(1));
      default -> form.parts().isEmpty() ? form.head() : said(form.part(form.parts().size() - 1));
    };
  }
}
