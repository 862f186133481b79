package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * A device with the features it offers, from the home file or from the description that it sends.
 *
 * @param individual its name is the member's id on the bus
 * @param container topic of the abstraction container its agent lives in, such as {@code lights}
 * @param driver which driver kind runs it in the simulation or on hardware, such as {@code lamp}
 * @param reports what the member reports of itself: the driver's own word for a value, and the fact
 *     it means, such as {@code level} and {@code (= (level ?self) ?level)}, {@code zone} and {@code
 *     (in ?self ?zone)}
 * @param settings what can be set at it, by name
 * @param pursues goals that its agent has of its own accord, with {@code ?self} for the device
 * @param worth of each of these goals
 * @param extension what its description brings beside the device itself
 */
public record Device(
    Individual individual,
    Optional<String> container,
    Optional<String> driver,
    List<FeatureType> features,
    Map<String, String> reports,
    Map<String, Setting> settings,
    List<Formula> pursues,
    StatedWorth worth,
    Extension extension) {
  private static final List<Term> SELF = List.of(Self.VARIABLE);

  public Device {
    features = List.copyOf(features);
    pursues = List.copyOf(pursues);
    reports = Collections.unmodifiableMap(new TreeMap<>(reports));
    settings = Collections.unmodifiableMap(new TreeMap<>(settings));
  }

  /** A device that speaks in the home's words, and says nothing of what its goals are worth. */
  public Device(
      Individual individual,
      Optional<String> container,
      Optional<String> driver,
      List<FeatureType> features,
      Map<String, String> reports,
      Map<String, Setting> settings,
      List<Formula> pursues) {
    this(
        individual,
        container,
        driver,
        features,
        reports,
        settings,
        pursues,
        StatedWorth.NONE,
        Extension.NONE);
  }

  /** The same without goals of its own, and with nothing to be set. */
  public Device(
      Individual individual,
      Optional<String> container,
      Optional<String> driver,
      List<FeatureType> features,
      Map<String, String> reports) {
    this(individual, container, driver, features, reports, Map.of(), List.of());
  }

  public String id() {
    return individual.name();
  }

  /**
   * What a host has to provide for the device's agent ({@code maestro:hostNeeds}): words, or words
   * with a blank and a number.
   */
  public Set<String> hostNeeds() {
    Set<String> needs = new TreeSet<>();
    for (Term need : individual.properties().getOrDefault("hostNeeds", List.of())) {
      if (need instanceof Term.Text text) {
        needs.add(text.value());
      } else if (need instanceof Term.Name name) {
        needs.add(name.text());
      }
    }
    return needs;
  }

  /**
   * The property of the device itself that its procedures call by a word of their own, such as
   * {@code payload} by {@code (payload ?self)}; empty when no feature of it says what that means.
   */
  public Optional<String> propertyCalled(String word) {
    return features.stream()
        .flatMap(feature -> Optional.ofNullable(feature.refersTo().get(word)).stream())
        .map(SlParser::fact)
        .filter(Fact.Holds.class::isInstance)
        .map(fact -> ((Fact.Holds) fact).atom())
        .filter(atom -> atom.arguments().equals(SELF))
        .map(Formula.Atom::predicate)
        .findFirst();
  }

  /** The same device, of which more is said: values by the property's local name. */
  public Device with(Map<String, List<Term>> more) {
    Map<String, List<Term>> all = new TreeMap<>(individual.properties());
    all.putAll(more);
    return new Device(
        new Individual(
            individual.name(), individual.iri(), individual.label(), individual.classes(), all),
        container,
        driver,
        features,
        reports,
        settings,
        pursues,
        worth,
        extension);
  }

  /** The same device with these features. */
  public Device offering(List<FeatureType> others) {
    return new Device(
        individual, container, driver, others, reports, settings, pursues, worth, extension);
  }

  /** The same device, whose description brings this. */
  public Device bringing(Extension more) {
    return new Device(
        individual, container, driver, features, reports, settings, pursues, worth, more);
  }

  /** Whether its description brings a thing of this name. */
  boolean brings(String thing) {
    return extension.things().containsKey(thing);
  }

  /** See {@link Individual#order}. */
  public double order() {
    return individual.order();
  }

  /** Whether it reports what this predicate says of it. */
  public boolean tells(String predicate) {
    return reports.values().stream().anyMatch(fact -> fact.contains("(" + predicate + " "));
  }
}
