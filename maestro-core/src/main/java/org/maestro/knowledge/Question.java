package org.maestro.knowledge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Answers {@code query-if} and {@code query-ref} from one snapshot. Immutable; any thread may ask.
 */
public final class Question {

  private final Snapshot snapshot;

  public Question(Snapshot snapshot) {
    this.snapshot = snapshot;
  }

  /**
   * Whether the formula holds; {@code UNKNOWN} differs from {@code FALSE}. Free variables are
   * existential.
   */
  public Truth queryIf(Formula formula) {
    return answerIf(formula).truth();
  }

  /**
   * As {@link #queryIf}, with the reasons; of an answer that is not true, those of all bindings.
   */
  public Answer answerIf(Formula formula) {
    Truth best = Truth.FALSE;
    List<Belief> because = new ArrayList<>();
    for (Map<String, Term> binding : candidates(formula)) {
      Answer answer = answer(formula, binding);
      if (answer.truth() == Truth.TRUE) {
        return answer;
      }
      because.addAll(answer.because());
      best = answer.truth() == Truth.UNKNOWN ? Truth.UNKNOWN : best;
    }
    return new Answer(best, Map.of(), because, snapshot.at());
  }

  /** As {@link #queryRef}, with the reasons for each. */
  public List<Answer> answerRef(Formula formula) {
    return candidates(formula).stream()
        .map(binding -> answer(formula, binding))
        .filter(answer -> answer.truth() == Truth.TRUE)
        .toList();
  }

  private Answer answer(Formula formula, Map<String, Term> binding) {
    List<Belief> because = new ArrayList<>();
    Truth truth = new Evaluation(snapshot.witnessed(because::add)).truth(formula, binding);
    return new Answer(truth, binding, because, snapshot.at());
  }

  /**
   * All bindings of the free variables, by name without question mark, with which the formula is
   * known to hold. Individuals come in the home's order, then other values that are known. Without
   * free variables: one empty binding when it holds.
   */
  public List<Map<String, Term>> queryRef(Formula formula) {
    return answerRef(formula).stream().map(Answer::binding).toList();
  }

  private List<Map<String, Term>> candidates(Formula formula) {
    Set<Term> values = new LinkedHashSet<>(snapshot.individuals(""));
    for (Belief belief : snapshot.beliefs()) {
      if (SlParser.fact(belief.fact()) instanceof Fact.Holds holds) {
        values.addAll(holds.atom().arguments());
      }
    }
    List<Map<String, Term>> bindings = List.of(new LinkedHashMap<>());
    for (String variable : FreeVariables.of(formula)) {
      List<Map<String, Term>> extended = new ArrayList<>();
      for (Map<String, Term> binding : bindings) {
        for (Term value : values) {
          Map<String, Term> with = new LinkedHashMap<>(binding);
          with.put(variable, value);
          extended.add(with);
        }
      }
      bindings = extended;
    }
    return bindings;
  }
}
