package org.maestro.knowledge.belief;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Fact;

/**
 * The last statements of each device about itself. A device tells all its values each time: what it
 * leaves out does not hold any more.
 */
public final class Statements {

  private final Map<String, Set<StateVariable>> byDevice = new TreeMap<>();
  private final Map<String, Set<StateVariable>> inFormerLives = new TreeMap<>();
  private final Map<String, Set<StateVariable>> expectedOf = new TreeMap<>();

  /**
   * Withdraws what the source does not say any more, and returns what is to be written.
   *
   * @param isMeant whether it is spoken of it now; of all else nothing is said
   * @param isNews of what is spoken of or left out; else somebody knows better already
   */
  public List<Fact> take(
      Source source,
      List<Fact> facts,
      Draft draft,
      PositionKeeping positions,
      Predicate<StateVariable> isMeant,
      Predicate<StateVariable> isNews) {
    Set<StateVariable> said = new LinkedHashSet<>();
    facts.forEach(fact -> said.add(draft.variable(FactReader.atom(fact))));
    withdrawn(draft.base(), source, said, isMeant).stream()
        .filter(isNews)
        .forEach(variable -> positions.withdraw(variable, source));
    Source expected = new Source(Source.Kind.EXPECTED, source.agent());
    notBroughtAbout(source, said, isMeant, isNews)
        .forEach(variable -> positions.withdraw(variable, expected));
    said.removeIf(isNews.negate());
    return facts.stream()
        .filter(fact -> said.contains(draft.variable(FactReader.atom(fact))))
        .toList();
  }

  /** The device is expected to have brought this about by a step of its own. */
  public void expects(World world, String device, List<Fact> facts) {
    Device described = world.home().devices().get(device);
    if (described == null) {
      return;
    }
    OwnReports reports = new OwnReports(described);
    for (Fact fact : facts) {
      if (fact instanceof Fact.Holds holds && reports.wouldTell(holds.atom())) {
        expectedOf
            .computeIfAbsent(device, name -> new LinkedHashSet<>())
            .add(world.declarations().spokenOf(fact));
      }
    }
  }

  /**
   * What was expected of the device, would be told by it now, and is not.
   *
   * @param isNews what was told of otherwise since is still expected
   */
  private List<StateVariable> notBroughtAbout(
      Source source,
      Set<StateVariable> said,
      Predicate<StateVariable> isMeant,
      Predicate<StateVariable> isNews) {
    if (source.kind() != Source.Kind.STATED || !expectedOf.containsKey(source.agent())) {
      return List.of();
    }
    Set<StateVariable> expected = expectedOf.get(source.agent());
    List<StateVariable> decided = expected.stream().filter(isMeant).filter(isNews).toList();
    decided.forEach(expected::remove);
    return decided.stream().filter(variable -> !said.contains(variable)).toList();
  }

  /**
   * Notes what is said now, and returns what was said before, is still believed on that word, and
   * is not repeated.
   */
  private List<StateVariable> withdrawn(
      World world, Source source, Set<StateVariable> said, Predicate<StateVariable> isMeant) {
    if (source.kind() != Source.Kind.STATED
        || !world.home().devices().containsKey(source.agent())) {
      return List.of();
    }
    Set<StateVariable> before = new LinkedHashSet<>();
    Optional.ofNullable(inFormerLives.remove(source.agent())).ifPresent(before::addAll);
    Optional.ofNullable(byDevice.remove(source.agent())).ifPresent(before::addAll);
    Set<StateVariable> now = new LinkedHashSet<>(said);
    before.stream().filter(isMeant.negate()).forEach(now::add);
    byDevice.put(source.agent(), now);
    return before.stream()
        .filter(variable -> !now.contains(variable))
        .filter(variable -> isOnItsWord(world, variable, source))
        .toList();
  }

  /** Whether it is what a device says of itself, and goes on saying until it says otherwise. */
  public boolean isStillSaid(StateVariable variable, Claim claim) {
    Source source = claim.held().source();
    return source.kind() == Source.Kind.STATED
        && byDevice.getOrDefault(source.agent(), Set.of()).contains(variable);
  }

  /**
   * The device is gone. What it has said of others and may be unknown is not known on its word any
   * more; all else is withdrawn when it comes without it, since to withdraw it is to deny it.
   */
  public void forget(World world, String device, PositionKeeping positions) {
    Source source = new Source(Source.Kind.STATED, device);
    Set<StateVariable> said =
        Optional.ofNullable(byDevice.remove(device)).orElseGet(LinkedHashSet::new);
    said.stream()
        .filter(variable -> mayBeUnknown(world, variable))
        .forEach(variable -> positions.withdraw(variable, source));
    said.removeIf(variable -> mayBeUnknown(world, variable));
    inFormerLives.computeIfAbsent(device, name -> new LinkedHashSet<>()).addAll(said);
    expectedOf.remove(device);
  }

  private static boolean mayBeUnknown(World world, StateVariable variable) {
    return world.declarations().isObservable(variable.predicate())
        || world.declarations().isFluent(variable.predicate());
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
