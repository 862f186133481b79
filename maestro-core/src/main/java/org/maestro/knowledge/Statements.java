package org.maestro.knowledge;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * What each device said of itself last. A device tells all its values each time: what it leaves out
 * does not hold any more.
 */
final class Statements {

  private final Map<String, Set<StateVariable>> byDevice = new TreeMap<>();

  /**
   * Notes what is said now, and returns what was said before, is still believed on that word, and
   * is not repeated.
   */
  List<StateVariable> withdrawn(World world, Source source, Set<StateVariable> said) {
    if (source.kind() != Source.Kind.STATED
        || !world.home().devices().containsKey(source.agent())) {
      return List.of();
    }
    Set<StateVariable> before = byDevice.put(source.agent(), new LinkedHashSet<>(said));
    return before == null
        ? List.of()
        : before.stream()
            .filter(variable -> !said.contains(variable))
            .filter(variable -> isOnItsWord(world, variable, source))
            .toList();
  }

  void forget(String device) {
    byDevice.remove(device);
  }

  private static boolean isOnItsWord(World world, StateVariable variable, Source source) {
    return world
        .cell(variable)
        .filter(
            cell ->
                cell.standing().stream().anyMatch(claim -> claim.held().source().equals(source)))
        .isPresent();
  }
}
