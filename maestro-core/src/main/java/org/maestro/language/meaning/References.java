package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** Notes, for one reading, which references are broken, and what follows for formulas. */
final class References {
  /** Of so many things nobody means the one of which something is not so yet. */
  private static final int MANY = 100;

  private final NounPhrases phrases;
  private final List<Doubt> doubts = new ArrayList<>();
  private int broken;
  private boolean dead;
  private boolean wished;

  References(NounPhrases phrases) {
    this.phrases = phrases;
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
      List<Formula> each = new ArrayList<>();
      for (Term term : several.terms()) {
        Optional<Formula> one = said.apply(term);
        if (one.isEmpty()) {
          return Optional.empty();
        }
        each.add(one.get());
      }
      return Optional.of(conjunction(each));
    } else if (reference instanceof Reference.All all) {
      return said.apply(new Term.Variable(all.variable().name()))
          .map(
              body ->
                  new Formula.Forall(
                      List.of(all.variable()),
                      all.conditions().isEmpty()
                          ? body
                          : new Formula.Imply(conjunction(all.conditions()), body)));
    } else if (reference instanceof Reference.Any any) {
      return said.apply(new Term.Variable(any.variable().name()))
          .map(
              body -> {
                List<Formula> parts = new ArrayList<>(any.conditions());
                parts.add(body);
                return new Formula.Exists(List.of(any.variable()), conjunction(parts));
              });
    }
    return reference instanceof Reference.Open open
        ? unlessSoAlready(open, said)
        : broken(reference);
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
    List<Formula> lacking = new ArrayList<>();
    for (Term.Name candidate : open.candidates()) {
      Optional<Formula> formula = said.apply(candidate);
      if (formula.isEmpty()) {
        return broken(open);
      }
      if (!phrases.relations().holds(formula.get(), Map.of())) {
        lacking.add(formula.get());
      }
    }
    if (lacking.size() != 1) {
      return broken(open);
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
    } else if (reference instanceof Reference.None none) {
      doubt(new Doubt.NoSuch(none.said()));
    } else if (reference instanceof Reference.Any || reference instanceof Reference.All) {
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
    return new org.maestro.sl.Substitution(terms).apply(formula);
  }
}
