package org.maestro.knowledge;

import java.util.List;
import java.util.Map;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * A feature's result, ready to be learnt from.
 *
 * @param bindings inputs and binds, {@code self} included
 * @param outputs by output name; empty unless it succeeded
 * @param refs what a failure teaches
 */
public record FeatureRun(
    String member,
    FeatureType feature,
    Map<String, Term> bindings,
    boolean succeeded,
    Map<String, Term> outputs,
    List<Learnt> refs) {

  /** A fluent or atom in MAESTRO-SL and the value found: a number, or a truth value. */
  public record Learnt(String fact, Term value) {}
}
