package org.maestro.ontology.vocabulary;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/**
 * A feature as data, f = (Id, r, I, O, phi, Pr, Po, Freq, Cost) (Three-layered architecture, 3.2.2;
 * M46): all that planner, knowledge and member need to know of it. The executing member is the
 * variable {@code ?self}.
 *
 * @param name local name, the feature's id on the bus
 * @param task true for a task (a sequence with a local plan), false for an atomic action
 * @param sentence for people, with {@code {self}} and {@code {parameter}} as place holders
 * @param inputs travel in the call; {@code binds} are chosen by the planner and stay with it
 * @param learns what a result teaches; absent: the effect itself is written
 * @param endedBy the feature that ends a continuous one
 * @param frequencyHertz upper limit or fixed rate of a continuous feature
 * @param occupies components of the member
 * @param claims what else it needs for itself while it runs
 * @param doubts why its results are less sure than its member is; none: as sure as the member
 * @param seconds expected duration, an expression
 * @param timing how long a call may take, and when its effect is there
 * @param reliability how often it works, and how often it may be tried
 * @param procedure the routine in the member's own software that runs it (phi); equals the name
 *     unless stated
 * @param refersTo what the routine calls a quantity (key) and the fact that is meant, such as
 *     {@code light} and {@code (illuminance ?zone)}; the fact is an atom or a fluent in MAESTRO-SL
 */
public record FeatureType(
    String name,
    String iri,
    boolean task,
    String sentence,
    List<Parameter> inputs,
    List<Parameter> binds,
    List<Parameter> outputs,
    Formula precondition,
    Effect effect,
    Optional<Effect> learns,
    boolean continuous,
    Optional<String> endedBy,
    OptionalDouble frequencyHertz,
    Set<String> occupies,
    List<Claim> claims,
    List<Doubt> doubts,
    Price cost,
    Expression seconds,
    Timing timing,
    Reliability reliability,
    Optional<String> exit,
    String procedure,
    Map<String, String> refersTo) {
  public FeatureType {
    inputs = List.copyOf(inputs);
    binds = List.copyOf(binds);
    outputs = List.copyOf(outputs);
    claims = List.copyOf(claims);
    doubts = List.copyOf(doubts);
    occupies = Collections.unmodifiableSet(new TreeSet<>(occupies));
    refersTo = Collections.unmodifiableMap(new TreeMap<>(refersTo));
  }

  /** Whether a condition, effect, price or duration of it speaks of that predicate or number. */
  public boolean speaksOf(String predicate) {
    Expression price =
        cost instanceof Price.Stated stated ? stated.cost() : ((Price.Asked) cost).atLeast();
    String all =
        String.join(
            " ",
            SlPrinter.print(precondition),
            SlPrinter.print(effect),
            learns.map(SlPrinter::print).orElse(""),
            SlPrinter.print(price),
            SlPrinter.print(seconds),
            timing.doneWhen().map(SlPrinter::print).orElse(""),
            String.join(" ", refersTo.values()));
    return all.contains("(" + predicate + " ");
  }

  /** The same feature with another effect. */
  public FeatureType withEffect(Effect other) {
    return with(inputs, precondition, other);
  }

  /** The same feature with another precondition. */
  public FeatureType withPrecondition(Formula other) {
    return with(inputs, other, effect);
  }

  /** The same feature with other inputs. */
  public FeatureType withInputs(List<Parameter> other) {
    return with(other, precondition, effect);
  }

  private FeatureType with(List<Parameter> given, Formula needed, Effect done) {
    return new FeatureType(
        name,
        iri,
        task,
        sentence,
        given,
        binds,
        outputs,
        needed,
        done,
        learns,
        continuous,
        endedBy,
        frequencyHertz,
        occupies,
        claims,
        doubts,
        cost,
        seconds,
        timing,
        reliability,
        exit,
        procedure,
        refersTo);
  }
}
