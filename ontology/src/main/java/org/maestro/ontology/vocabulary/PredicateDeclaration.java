package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * A predicate or numeric fluent of the vocabulary.
 *
 * @param fluent true when its value is a number
 * @param observable true, false or unknown; others are closed-world
 * @param functional its last argument is the value of a state variable of the arguments before
 * @param validFor age after which an observed fact is unknown again; {@code validForByClass}
 *     overrides it by class of the first argument
 * @param derivedWhen holds exactly when the formula does; never in effects
 * @param observedWhen an observation of positions decides it; may be set by effects too
 * @param likelyWhen where an unknown atom is expected first, {@code (usuallyIn ?x ?p)}
 * @param computedBy local name of a geometry function
 * @param least no value of the fluent is below it
 * @param takenFrom where its number comes from unless it is stated by itself
 * @param countedWhen its number is how often this has become so, about this time of day
 * @param shareOf the number in which its number has a share, so that it is learnt from measurements
 * @param isPrivate its facts are told to those alone whom the home permits that
 */
public record PredicateDeclaration(
    String name,
    String iri,
    String label,
    List<TypedVariable> parameters,
    boolean fluent,
    boolean observable,
    boolean functional,
    boolean symmetric,
    Optional<Duration> validFor,
    Map<String, Duration> validForByClass,
    Optional<Formula> derivedWhen,
    Optional<Formula> observedWhen,
    Optional<Formula> likelyWhen,
    Optional<String> computedBy,
    Optional<String> unit,
    OptionalDouble least,
    Optional<TakenFrom> takenFrom,
    Optional<Formula> countedWhen,
    Optional<Share> shareOf,
    boolean isPrivate) {
  /** QUDT's names of units, as people write them. */
  private static final Map<String, String> UNIT_SYMBOLS =
      Map.of(
          "LUX",
          "lux",
          "M",
          "m",
          "KiloGM",
          "kg",
          "M-PER-SEC",
          "m/s",
          "W",
          "W",
          "MIN",
          "min",
          "SEC",
          "s",
          "K",
          "K",
          "DEG_C",
          "°C");

  public PredicateDeclaration {
    parameters = List.copyOf(parameters);
    validForByClass = Collections.unmodifiableMap(new TreeMap<>(validForByClass));
  }

  /** One that counts and learns nothing, and whose facts everybody may be told. */
  public PredicateDeclaration(
      String name,
      String iri,
      String label,
      List<TypedVariable> parameters,
      boolean fluent,
      boolean observable,
      boolean functional,
      boolean symmetric,
      Optional<Duration> validFor,
      Map<String, Duration> validForByClass,
      Optional<Formula> derivedWhen,
      Optional<Formula> observedWhen,
      Optional<Formula> likelyWhen,
      Optional<String> computedBy,
      Optional<String> unit,
      OptionalDouble least,
      Optional<TakenFrom> takenFrom) {
    this(
        name,
        iri,
        label,
        parameters,
        fluent,
        observable,
        functional,
        symmetric,
        validFor,
        validForByClass,
        derivedWhen,
        observedWhen,
        likelyWhen,
        computedBy,
        unit,
        least,
        takenFrom,
        Optional.empty(),
        Optional.empty(),
        false);
  }

  /** How it is written, such as {@code (nextTo ?a - Thing ?b - Thing)}. */
  public String form() {
    return parameters.stream()
        .map(parameter -> " " + SlPrinter.print(parameter))
        .collect(Collectors.joining("", "(" + name, ")"));
  }

  /** The unit as people write it after a number, with a blank before it; "" when there is none. */
  public String unitAfterNumber() {
    return unit.map(name -> " " + UNIT_SYMBOLS.getOrDefault(name, name)).orElse("");
  }

  /**
   * The same without what people read and who may, and with its arguments called by their places.
   */
  PredicateDeclaration unlabelled() {
    Map<String, Term> places = new TreeMap<>();
    List<TypedVariable> numbered = new ArrayList<>();
    for (TypedVariable parameter : parameters) {
      String place = String.valueOf(numbered.size() + 1);
      places.put(parameter.name(), new Term.Variable(place));
      numbered.add(new TypedVariable(place, parameter.className()));
    }
    Substitution called = new Substitution(places);
    return new PredicateDeclaration(
        name,
        iri,
        "",
        numbered,
        fluent,
        observable,
        functional,
        symmetric,
        validFor,
        validForByClass,
        derivedWhen.map(called::apply),
        observedWhen.map(called::apply),
        likelyWhen.map(called::apply),
        computedBy,
        unit,
        least,
        takenFrom,
        countedWhen.map(called::apply),
        shareOf.map(share -> share.with(called)),
        isPrivate);
  }
}
