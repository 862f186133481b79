package org.maestro.language.wording;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.Objection;
import org.maestro.ontology.permission.Way;
import org.maestro.ontology.wording.Said;
import org.maestro.ontology.wording.StateWord;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** What a person is told who may not have something done: how far she may go, and who may. */
public final class RefusalWords {
  private static final String IT = "it";

  private final Home home;
  private final Grammar grammar;
  private final Naming naming;

  public RefusalWords(Home home, Grammar grammar) {
    this.home = home;
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
  }

  /** The sentence. */
  public String of(Objection objection) {
    String may = objection.limit().map(this::limit).orElseGet(() -> mayNot(objection.way()));
    String whole = withOthers(may, objection);
    return capitalized(
        objection
            .person()
            .map(
                person ->
                    phrase("refusal-to", Map.of("person", naming.word(person), "sentence", whole)))
            .orElse(whole));
  }

  private String limit(Objection.Limit limit) {
    String name =
        switch (limit.relation()) {
          case AT_MOST -> "limit-most";
          case LESS -> "limit-below";
          case AT_LEAST -> "limit-least";
          case GREATER -> "limit-above";
          case EQUAL -> "limit-only";
        };
    return phrase(
        name, Map.of("what", property(limit.what()), "number", SlPrinter.print(limit.number())));
  }

  private String property(Expression.Fluent fluent) {
    String property = naming.bare(fluent.name());
    return fluent.arguments().isEmpty()
        ? property
        : phrase(
            "limit-of",
            Map.of("property", property, "thing", naming.of(fluent.arguments().get(0))));
  }

  private String mayNot(Way way) {
    String thing = naming.word(way.device().id());
    return state(way)
        .map(state -> phrase("refusal-state", Map.of("thing", thing, "state", state)))
        .or(
            () ->
                number(way)
                    .map(fluent -> phrase("refusal-number", Map.of("what", property(fluent)))))
        .orElseGet(() -> grammar.phrase("refusal-that"));
  }

  /** What the device is called once it is done. */
  private Optional<String> state(Way way) {
    Substitution toIt = new Substitution(Map.of(Self.VARIABLE.name(), new Term.Variable(IT)));
    List<Formula> brought =
        leaves(way.feature().effect())
            .flatMap(effect -> brought(toIt.apply(effect)).stream())
            .toList();
    return home.wording().states().stream()
        .filter(state -> way.device().individual().classes().contains(state.of()))
        .filter(state -> state.broughtAboutBy().filter(brought::contains).isPresent())
        .map(StateWord::says)
        .flatMap(List::stream)
        .filter(said -> said.isIn(grammar.language()))
        .map(Said::text)
        .findFirst();
  }

  private static Optional<Formula> brought(Effect effect) {
    if (effect instanceof Effect.Add add) {
      return Optional.of(add.atom());
    }
    return effect instanceof Effect.Delete delete
        ? Optional.of(new Formula.Not(delete.atom()))
        : Optional.empty();
  }

  private static Optional<Expression.Fluent> number(Way way) {
    return leaves(way.feature().effect())
        .filter(Effect.Change.class::isInstance)
        .map(effect -> new Substitution(way.values()).apply(((Effect.Change) effect).fluent()))
        .filter(fluent -> fluent.arguments().stream().allMatch(Term::isGround))
        .findFirst();
  }

  private static Stream<Effect> leaves(Effect effect) {
    return effect instanceof Effect.All all
        ? all.effects().stream().flatMap(RefusalWords::leaves)
        : Stream.of(effect);
  }

  private String withOthers(String may, Objection objection) {
    List<String> names = objection.others().stream().map(naming::word).toList();
    if (names.isEmpty()) {
      return phrase("refusal-alone", Map.of("sentence", may));
    }
    int last = names.size() - 1;
    String who =
        last == 0
            ? names.get(0)
            : phrase(
                "any-of",
                Map.of(
                    "first", String.join(", ", names.subList(0, last)), "last", names.get(last)));
    String name =
        objection
            .limit()
            .map(
                limit ->
                    switch (limit.relation()) {
                      case AT_MOST, LESS -> "refusal-higher";
                      case AT_LEAST, GREATER -> "refusal-lower";
                      case EQUAL -> "refusal-others";
                    })
            .orElse("refusal-others");
    return phrase(name, Map.of("sentence", may, "who", who));
  }

  private String phrase(String name, Map<String, String> values) {
    String phrase = grammar.phrase(name);
    for (Map.Entry<String, String> value : values.entrySet()) {
      phrase = phrase.replace("{" + value.getKey() + "}", value.getValue());
    }
    return phrase;
  }

  private static String capitalized(String text) {
    return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }
}
