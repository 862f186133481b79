package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.sl.Term;

/**
 * An access rule that a home states: its callers, the agents that they may ask, for which features,
 * the private words that they may read, and the parts of agents that they may use.
 *
 * @param callers names of agents and of users; "*" is everybody
 * @param asks names of devices and of device classes, with parts of agents, too; empty: all
 * @param permits names of feature types; empty: all features
 * @param reads names of private words; empty: none
 * @param opens names of parts of agents; empty: none
 */
public record Permission(
    Set<String> callers,
    Set<String> asks,
    Set<String> permits,
    Set<String> reads,
    Set<String> opens) {
  /** Everybody, among callers. */
  public static final String ANYBODY = "*";

  public Permission {
    callers = sorted(callers);
    asks = sorted(asks);
    permits = sorted(permits);
    reads = sorted(reads);
    opens = sorted(opens);
  }

  static Permission of(Individual stated) {
    return new Permission(
        names(stated, "caller"),
        names(stated, "asks"),
        names(stated, "permits"),
        names(stated, "reads"),
        names(stated, "opens"));
  }

  /** Whether it says nothing of asking for features. */
  boolean isOfNoFeature() {
    return permits.isEmpty() && (!opens.isEmpty() || !reads.isEmpty() && asks.isEmpty());
  }

  boolean isAbout(Device device) {
    return asks.isEmpty()
        || asks.contains(device.id())
        || device.individual().classes().stream().anyMatch(asks::contains);
  }

  /**
   * @param names all by which the caller is known
   */
  boolean isFor(Set<String> names) {
    return callers.contains(ANYBODY) || names.stream().anyMatch(callers::contains);
  }

  boolean covers(String feature) {
    return permits.isEmpty() || permits.contains(feature);
  }

  static Set<String> names(Individual stated, String property) {
    return stated.properties().getOrDefault(property, List.of()).stream()
        .map(Permission::name)
        .collect(Collectors.toSet());
  }

  private static String name(Term term) {
    if (term instanceof Term.Text text) {
      return text.value();
    }
    return term instanceof Term.Name name ? name.text() : term.toString();
  }

  private static Set<String> sorted(Set<String> names) {
    return Collections.unmodifiableSet(new TreeSet<>(names));
  }
}
