package org.maestro.ontology.home;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The parts of agents that a home opens to some callers alone. A part of which it says nothing is
 * open to everybody, as it was before there were such permissions. Immutable.
 *
 * @param openings empty: all parts are open
 */
public record PartList(List<Opening> openings) {
  public PartList {
    openings = List.copyOf(openings);
  }

  /**
   * Parts that are open to some.
   *
   * @param callers names of agents and of users; "*" is everybody
   * @param agents whose parts; empty: of all agents that have them
   */
  record Opening(Set<String> callers, Set<String> agents, Set<String> parts) {
    boolean isOf(String agent, Part part) {
      return parts.contains(part.word()) && (agents.isEmpty() || agents.contains(agent));
    }

    boolean isFor(Set<String> names) {
      return callers.contains(Permission.ANYBODY) || names.stream().anyMatch(callers::contains);
    }
  }

  public static PartList of(Home home) {
    return new PartList(
        home.of("Permission").stream()
            .map(Permission::of)
            .filter(permission -> !permission.opens().isEmpty())
            .map(
                permission ->
                    new Opening(
                        permission.callers(), agents(home, permission.asks()), permission.opens()))
            .toList());
  }

  /** Those that are named, and those of the classes that are. */
  private static Set<String> agents(Home home, Set<String> asks) {
    Set<String> agents = new TreeSet<>(asks);
    home.individuals().values().stream()
        .filter(individual -> individual.classes().stream().anyMatch(asks::contains))
        .map(Individual::name)
        .forEach(agents::add);
    return agents;
  }

  /**
   * Why the agent does not let the caller use this part of it.
   *
   * @param caller all names by which the caller is known
   * @return empty when he may
   */
  public Optional<String> objection(Set<String> caller, String agent, Part part) {
    List<Opening> about = openings.stream().filter(one -> one.isOf(agent, part)).toList();
    boolean isAllowed = about.isEmpty() || about.stream().anyMatch(one -> one.isFor(caller));
    return isAllowed
        ? Optional.empty()
        : Optional.of(
            "no maestro:Permission of the home opens the %s of %s to %s"
                .formatted(part.word(), agent, String.join(" or ", new TreeSet<>(caller))));
  }
}
