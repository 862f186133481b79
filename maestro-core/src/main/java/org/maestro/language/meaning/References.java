package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** Notes, for one reading, which references are broken, and what follows for formulas. */
final class References {
  /** Of so many things nobody means the one of which something is not so yet. */
  private static final int MANY = 100;

  private final NounPhrases phrases;
  private final Settables settables;
  private final List<Doubt> doubts = new ArrayList<>();
  private int broken;
  private boolean dead;
  private boolean wished;

  References(NounPhrases phrases, Settables settables) {
    this.phrases = phrases;
    this.settables = settables;
  }

  NounPhrases phrases() {
    return phrases;
  }

  List<Doubt> doubts() {
    return doubts;
  }

  int broken() {
    return broken;
  }

  /** Whether it cannot be meant so at all. */
  boolean isDead() {
    return dead;
  }

  void doubt(Doubt doubt) {
    doubts.add(doubt);
    broken++;
  }

  /** The reading cannot be meant: what was said is of another kind than what is wanted. */
  void die() {
    dead = true;
  }

  /**
   * The formula for what the phrase refers to: for each of several, for all or for some.
   *
   * @return empty when the reference is broken, which is noted
   */
  Optional<Formula> over(Form phrase, String className, Function<Term, Optional<Formula>> said) {
    return over(phrases.resolve(phrase, className), said);
  }

  Optional<Formula> over(Reference reference, Function<Term, Optional<Formula>> said) {
    if (reference instanceof Reference.Single single) {
      return said.apply(single.term());
    } else if (reference instanceof Reference.Several several) {
      return each(several, said);
    } else if (reference instanceof Reference.All all) {
      return said.apply(new Term.Variable(all.variable().name()))
          .map(
              body ->
                  new Formula.Forall(
                      List.of(all.variable()),
                      all.conditions().isEmpty()
                          ? body
                          : new Formula.Imply(conjunction(all.conditions()), body)));
    } else if (reference instanceof Reference.Any any && wished && isPlaced(any)) {
      return placed(any, said);
    } else if (reference instanceof Reference.Any any) {
      return said.apply(new Term.Variable(any.variable().name()))
          .map(
              body -> {
                List<Formula> parts = new ArrayList<>(any.conditions());
                parts.add(body);
                return new Formula.Exists(List.of(any.variable()), conjunction(parts));
              });
    }
    if (reference instanceof Reference.Either either) {
      return either(either, said);
    }
    if (reference instanceof Reference.Open open) {
      return !wished && isOfAll(open)
          ? each(new Reference.Several(List.copyOf(open.candidates())), said)
          : unlessSoAlready(open, said);
    }
    return broken(reference);
  }

  /** Of all that are elsewhere nothing is done unasked; what is so of them can be told. */
  private static boolean isOfAll(Reference.Open open) {
    return open.said().is("np")
        && (open.said().text(0).equals("all") || open.said().text(0).equals("every"));
  }

  /** Whether it is said where any of them is, which changes when one is moved. */
  private boolean isPlaced(Reference.Any any) {
    return any.conditions().stream().anyMatch(this::mayChange);
  }

  private boolean mayChange(Formula condition) {
    return condition instanceof Formula.Or or
        ? or.operands().stream().allMatch(this::mayChange)
        : condition instanceof Formula.Atom && settables.mayBringAbout(condition);
  }

  private Reference.Any anywhere(Reference.Any any) {
    return new Reference.Any(
        any.variable(),
        any.conditions().stream().filter(condition -> !mayChange(condition)).toList());
  }

  /** What is to be moved is one of those that are there now; when nobody knows any, any will do. */
  private Optional<Formula> placed(Reference.Any any, Function<Term, Optional<Formula>> said) {
    List<Reference> there =
        phrases.those(any).stream().<Reference>map(Reference.Single::new).toList();
    if (there.isEmpty()) {
      return over(anywhere(any), said);
    }
    List<Formula> options = new ArrayList<>();
    for (Reference one : there) {
      Optional<Formula> option = over(one, said);
      if (option.isEmpty()) {
        return option;
      }
      options.add(option.get());
    }
    return Optional.of(options.size() == 1 ? options.get(0) : new Formula.Or(options));
  }

  /** Of several things that are to be so those that can. */
  private Optional<Formula> each(
      Reference.Several several, Function<Term, Optional<Formula>> said) {
    List<Formula> each = new ArrayList<>();
    for (Term term : several.terms()) {
      Optional<Formula> one = said.apply(term);
      if (one.isEmpty()) {
        return Optional.empty();
      }
      each.add(one.get());
    }
    List<Formula> able =
        wished
            ? each.stream()
                .filter(settables::mayBringAbout)
                .filter(goal -> !settables.isOutOfReach(goal))
                .toList()
            : List.of();
    return Optional.of(conjunction(able.isEmpty() ? each : able));
  }

  /** Of two things that are named it is asked which; of two kinds of things any will do. */
  private Optional<Formula> either(
      Reference.Either either, Function<Term, Optional<Formula>> said) {
    if (wished && either.named().isPresent()) {
      return broken(either);
    }
    List<Formula> options = new ArrayList<>();
    for (Reference option : either.options()) {
      Optional<Formula> one = over(option, said);
      if (one.isEmpty()) {
        return Optional.empty();
      }
      options.add(one.get());
    }
    return Optional.of(new Formula.Or(options));
  }

  private Optional<Formula> broken(Reference reference) {
    note(reference);
    return Optional.empty();
  }

  /** What is so already is not asked for: of several candidates the only one of which it is not. */
  private Optional<Formula> unlessSoAlready(
      Reference.Open open, Function<Term, Optional<Formula>> said) {
    if (!wished || open.candidates().size() > MANY) {
      return broken(open);
    }
    Map<Term.Name, Formula> able = new LinkedHashMap<>();
    for (Term.Name candidate : open.candidates()) {
      Optional<Formula> formula = said.apply(candidate);
      if (formula.isEmpty()) {
        return broken(open);
      }
      if (settables.mayBringAbout(formula.get())) {
        able.put(candidate, formula.get());
      }
    }
    if (able.size() == 1) {
      phrases.spokenOf(able.keySet().iterator().next());
      return Optional.of(able.values().iterator().next());
    }
    List<Formula> lacking =
        able.values().stream()
            .filter(formula -> !phrases.relations().holds(formula, Map.of()))
            .toList();
    if (lacking.size() != 1) {
      return broken(
          able.isEmpty() ? open : new Reference.Open(open.said(), List.copyOf(able.keySet())));
    }
    broken++;
    return Optional.of(lacking.get(0));
  }

  /** From now on what is said is wished, rather than asked or told. */
  void wishing() {
    wished = true;
  }

  /** The things that a phrase refers to, where no formula is wanted. */
  Optional<List<Term>> terms(Form phrase, String className) {
    Reference reference = phrases.resolve(phrase, className);
    if (reference instanceof Reference.Single single) {
      return Optional.of(List.of(single.term()));
    } else if (reference instanceof Reference.Several several) {
      return Optional.of(several.terms());
    }
    note(reference);
    return Optional.empty();
  }

  private void note(Reference reference) {
    if (reference instanceof Reference.Open open) {
      doubt(new Doubt.Which(open.said(), open.candidates()));
    } else if (reference instanceof Reference.Either either && either.named().isPresent()) {
      doubt(new Doubt.Which(either.said(), either.named().get()));
    } else if (reference instanceof Reference.None none) {
      doubt(new Doubt.NoSuch(none.said()));
      // What could be meant of several is likelier than what is nowhere.
      broken++;
    } else if (reference instanceof Reference.Any
        || reference instanceof Reference.All
        || reference instanceof Reference.Either) {
      doubt(new Doubt.Nothing("all and any are not meant there"));
    } else {
      die();
    }
  }

  static Formula conjunction(List<Formula> parts) {
    List<Formula> flat = new ArrayList<>();
    for (Formula part : parts) {
      if (part instanceof Formula.And and) {
        flat.addAll(and.operands());
      } else {
        flat.add(part);
      }
    }
    List<Formula> distinct = flat.stream().distinct().toList();
    return distinct.size() == 1 ? distinct.get(0) : new Formula.And(distinct);
  }

  static Formula substituted(Formula formula, Map<String, Term> terms) {
    return new Substitution(terms).apply(formula);
  }
}
