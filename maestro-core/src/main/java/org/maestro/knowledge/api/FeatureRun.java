package org.maestro.knowledge.api;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * A feature's result, ready to be learnt from.
 *
 * @param bindings inputs and binds, {@code self} included
 * @param outputs by output name; empty unless it succeeded
 * @param refs what a failure teaches
 * @param before what was known when the step began: the effect's conditions and amounts are read
 *     from it, for the member may have told its new state before the result came; absent: what is
 *     known when the result is learnt
 * @param begun false when the member did not even start, so that all is as it was
 * @param account what the member said of itself around it; absent: nobody has listened
 */
public record FeatureRun(
    String member,
    FeatureType feature,
    Map<String, Term> bindings,
    boolean succeeded,
    Map<String, Term> outputs,
    List<Learnt> refs,
    Optional<Snapshot> before,
    boolean begun,
    Optional<StepAccount> account) {

  public FeatureRun(
      String member,
      FeatureType feature,
      Map<String, Term> bindings,
      boolean succeeded,
      Map<String, Term> outputs,
      List<Learnt> refs,
      Optional<Snapshot> before,
      boolean begun) {
    this(member, feature, bindings, succeeded, outputs, refs, before, begun, Optional.empty());
  }

  public FeatureRun(
      String member,
      FeatureType feature,
      Map<String, Term> bindings,
      boolean succeeded,
      Map<String, Term> outputs,
      List<Learnt> refs) {
    this(member, feature, bindings, succeeded, outputs, refs, Optional.empty(), true);
  }

  /**
   * A fluent or atom in MAESTRO-SL and the value found: a number, or a truth value.
   *
   * @param need what its member insists on, such as {@code >= 72} or {@code false}; absent: it does
   *     not say
   */
  public record Learnt(String fact, Term value, Optional<String> need) {

    /** Of which nothing is insisted on. */
    public Learnt(String fact, Term value) {
      this(fact, value, Optional.empty());
    }
  }
}
