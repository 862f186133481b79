package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.wording.Said;
import org.maestro.ontology.wording.StateWord;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * What is so, as people say it: by the words of states where there are some, by where things are,
 * and else by the words of predicates and numbers. Immutable.
 */
public final class FactWords {
  private static final String SO = "so";
  private static final String NOT_SO = "not-so";
  private static final String TOLD = "told";
  private static final String NOT_TOLD = "not-told";
  private static final String ONE = "";
  private static final String MANY = "-many";
  private static final String YOU = "-you";

  private static final Map<String, String> DENIED = Map.of(SO, NOT_SO, TOLD, NOT_TOLD);

  private final Home home;
  private final Grammar grammar;
  private final Naming naming;
  private final Phrases phrases;
  private final AmountWords amounts;
  private final NamedTerms terms;

  /**
   * In a language.
   *
   * @param listener the person who is spoken to, by her name in the home
   */
  public FactWords(Home home, Grammar grammar, Optional<String> listener) {
    this.home = home;
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
    this.phrases = new Phrases(grammar);
    this.amounts = new AmountWords(home, grammar);
    this.terms = new NamedTerms(home, grammar, listener);
  }

  /**
   * Something that is said of something.
   *
   * @param count end of the phrase's name: of several, of who is spoken to, else of one
   * @param phrase by which both are put together
   */
  private record Clause(String subject, String count, String phrase, String rest) {}

  /** A sentence that tells it; empty when there are no words for it. */
  public Optional<String> sentence(Formula formula) {
    return of(formula).map(Phrases::sentence);
  }

  /**
   * A sentence that tells when it will be so; empty when there are no words for that.
   *
   * @param span until then, in words
   */
  public Optional<String> foretold(Formula formula, String span) {
    for (StateWord state : home.wording().states()) {
      Optional<Term> it = thing(state, formula);
      Optional<String> sentence = in(state.foretells());
      if (it.isPresent() && sentence.isPresent() && terms.isA(it.get(), state.of())) {
        return terms
            .subject(it.get())
            .map(
                text ->
                    Phrases.capitalized(
                        sentence.get().replace("{it}", text).replace("{span}", span)));
      }
    }
    return Optional.empty();
  }

  private static Optional<Term> thing(StateWord state, Formula formula) {
    return state
        .broughtAboutBy()
        .flatMap(wanted -> Matching.of(wanted, formula))
        .or(() -> Matching.of(state.holdsWhen(), formula))
        .map(bound -> bound.get("it"));
  }

  /** The same as a part of a sentence. */
  public Optional<String> of(Formula formula) {
    return clauses(formula, terms).map(this::joined);
  }

  /** What is said of several in the same words is said once. */
  private String joined(List<Clause> clauses) {
    Map<String, List<Clause>> alike = new LinkedHashMap<>();
    for (Clause clause : clauses) {
      alike
          .computeIfAbsent(clause.phrase() + " " + clause.rest(), key -> new ArrayList<>())
          .add(clause);
    }
    return phrases.listed(alike.values().stream().map(this::together).toList());
  }

  private String together(List<Clause> clauses) {
    Clause first = clauses.get(0);
    if (first.phrase().equals(TOLD)) {
      return phrases.listed(clauses.stream().map(Clause::subject).distinct().toList());
    }
    if (first.phrase().equals(NOT_TOLD)) {
      return phrases.of(NOT_TOLD, Map.of("fact", first.subject()));
    }
    return phrases.of(
        first.phrase() + (clauses.size() > 1 ? MANY : first.count()),
        Map.of(
            "thing",
            phrases.listed(clauses.stream().map(Clause::subject).distinct().toList()),
            "how",
            first.rest()));
  }

  private Optional<List<Clause>> clauses(Formula formula, NamedTerms named) {
    Optional<Clause> state = inState(formula, named);
    if (state.isPresent()) {
      return state.map(List::of);
    } else if (formula instanceof Formula.And and) {
      return all(and.operands(), named);
    } else if (formula instanceof Formula.Keep keep) {
      return clauses(keep.body(), named);
    } else if (formula instanceof Formula.Exists exists) {
      return clauses(exists.body(), named.within(exists.variables(), exists.body(), false));
    } else if (formula instanceof Formula.Forall forall) {
      return clauses(forall.body(), named.within(forall.variables(), forall.body(), true));
    } else if (formula instanceof Formula.Not not) {
      return clauses(not.operand(), named)
          .filter(inner -> inner.size() == 1)
          .flatMap(inner -> denied(inner.get(0)))
          .map(List::of);
    } else if (formula instanceof Formula.Atom atom) {
      return related(atom, named).map(List::of);
    } else if (formula instanceof Formula.Comparison comparison) {
      return compared(comparison, named).map(List::of);
    }
    return Optional.empty();
  }

  private Optional<List<Clause>> all(List<Formula> parts, NamedTerms named) {
    List<Clause> all = new ArrayList<>();
    for (Formula part : parts) {
      if (named.isClass(part)) {
        continue;
      }
      Optional<List<Clause>> of = clauses(part, named);
      if (of.isEmpty()) {
        return Optional.empty();
      }
      all.addAll(of.get());
    }
    return all.isEmpty() ? Optional.empty() : Optional.of(all);
  }

  private Optional<Clause> inState(Formula formula, NamedTerms named) {
    for (StateWord state : home.wording().states()) {
      Optional<Term> it = thing(state, formula);
      Optional<String> word = in(state.says());
      if (it.isPresent() && word.isPresent() && named.isA(it.get(), state.of())) {
        return named
            .subject(it.get())
            .map(text -> new Clause(text, count(it.get(), named), SO, word.get()));
      }
    }
    return Optional.empty();
  }

  private static String count(Term term, NamedTerms named) {
    return named.isListener(term) ? YOU : named.isMany(term) ? MANY : ONE;
  }

  private Optional<String> in(List<Said> said) {
    return said.stream().filter(one -> one.isIn(grammar.language())).map(Said::text).findFirst();
  }

  private Optional<Clause> related(Formula.Atom atom, NamedTerms named) {
    if (home.scripts().containsKey(atom.predicate())) {
      return Optional.empty();
    }
    List<String> words =
        atom.arguments().stream().map(named::text).flatMap(Optional::stream).toList();
    if (words.isEmpty() || words.size() < atom.arguments().size()) {
      return Optional.empty();
    }
    Optional<String> told = in(home.wording().told().getOrDefault(atom.predicate(), List.of()));
    if (told.isPresent()) {
      String clause = told(told.get(), atom.predicate(), words);
      return Optional.of(new Clause(clause, ONE, TOLD, clause));
    }
    String subject = named.subject(atom.arguments().get(0)).orElse(words.get(0));
    String count = count(atom.arguments().get(0), named);
    if (home.vocabulary().classes().containsKey(atom.predicate())) {
      return Optional.of(
          new Clause(subject, count, SO, phrases.any(naming.word(atom.predicate()))));
    }
    String others = words.stream().skip(1).collect(Collectors.joining(", "));
    return in(home.wording().prepositions().getOrDefault(atom.predicate(), List.of()))
        .map(how -> phrases.of("placed", Map.of("how", how, "thing", others)))
        .or(
            () ->
                Optional.of(atom.predicate())
                    .filter(naming::isNamed)
                    .map(name -> (naming.word(name) + " " + others).strip()))
        .map(how -> new Clause(subject, count, SO, how));
  }

  private static Optional<Clause> denied(Clause clause) {
    return Optional.ofNullable(DENIED.get(clause.phrase()))
        .map(phrase -> new Clause(clause.subject(), clause.count(), phrase, clause.rest()));
  }

  /** A clause of the predicate's own, by the names of its arguments. */
  private String told(String clause, String predicate, List<String> words) {
    Map<String, String> values = new HashMap<>();
    List<TypedVariable> parameters =
        home.vocabulary().predicate(predicate).orElseThrow().parameters();
    for (int i = 0; i < parameters.size(); i++) {
      values.put(parameters.get(i).name(), words.get(i));
    }
    return phrases.filled(clause, values);
  }

  private Optional<Clause> compared(Formula.Comparison comparison, NamedTerms named) {
    if (!(comparison.left() instanceof Expression.Fluent fluent)
        || !(comparison.right() instanceof Expression.OfTerm value)) {
      return Optional.empty();
    }
    List<String> whose =
        fluent.arguments().stream().map(named::text).flatMap(Optional::stream).toList();
    if (whose.size() < fluent.arguments().size() || !naming.isNamed(fluent.name())) {
      return Optional.empty();
    }
    String measure = naming.bare(fluent.name());
    String subject =
        whose.isEmpty()
            ? measure
            : phrases.of(
                "measure-of",
                Map.of(
                    "measure",
                    measure,
                    "named",
                    naming.word(fluent.name()),
                    "thing",
                    String.join(", ", whose)));
    return amount(fluent.name(), comparison.relation(), value.term(), named)
        .map(amount -> new Clause(subject, ONE, phrase(comparison.relation()), amount));
  }

  private static String phrase(Formula.Relation relation) {
    return switch (relation) {
      case LESS -> "number-less";
      case AT_MOST -> "number-at-most";
      case EQUAL -> SO;
      case AT_LEAST -> "number-at-least";
      case GREATER -> "number-greater";
    };
  }

  /** A number of it, as a share where it is one, else with its unit. */
  private Optional<String> amount(
      String fluent, Formula.Relation relation, Term value, NamedTerms named) {
    if (!(value instanceof Term.Number number)) {
      return named.text(value);
    }
    return Optional.of(
        relation == Formula.Relation.EQUAL
            ? amounts.of(fluent, number.value())
            : amounts.exactly(fluent, number.value()));
  }
}
