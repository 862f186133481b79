package org.maestro.platform;

import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Deployment;
import org.maestro.ontology.home.Home;

/**
 * Those whom the supervisor has started, or taken in, for members, and the agents of the home's
 * groups. On a secured site no guest is one, whatever his agent is called: guests ask, and the bus
 * does not know them. Any thread may ask.
 */
final class DeployedSpokesmen implements Spokesmen {
  private static final Set<String> CENTRAL =
      Set.of(AgentNames.COORDINATOR, AgentNames.KNOWLEDGE, AgentNames.SUPERVISOR);

  private final Deployment deployment;
  private final Supplier<Home> home;
  private final Predicate<String> isGuest;

  /**
   * @param isGuest whether a user of a secured site is one
   */
  DeployedSpokesmen(Deployment deployment, Supplier<Home> home, Predicate<String> isGuest) {
    this.deployment = deployment;
    this.home = home;
    this.isGuest = isGuest;
  }

  @Override
  public Optional<String> objection(Caller caller, String subject) {
    if (isGuest(caller)) {
      return Optional.of(
          "%s is an agent of a guest, and guests speak for nobody but themselves."
              .formatted(caller));
    }
    Optional<String> its =
        deployment
            .agentOf(subject)
            .map(AgentStart::agent)
            .or(() -> Optional.of(subject).filter(home.get().groups()::containsKey));
    if (its.isEmpty()) {
      return Optional.of(
          "No agent of this platform stands for %s, and %s does not speak for it."
              .formatted(subject, caller));
    }
    return its.filter(caller.agent()::equals).isPresent()
        ? Optional.empty()
        : Optional.of(Spokesmen.notItsOwn(caller, subject));
  }

  @Override
  public boolean isOwn(Caller caller) {
    String agent = caller.agent();
    return !isGuest(caller)
        && (CENTRAL.contains(agent)
            || deployment.find(agent).isPresent()
            || home.get().groups().containsKey(agent)
            || home.get().tracking().filter(its -> its.agent().equals(agent)).isPresent());
  }

  private boolean isGuest(Caller caller) {
    return caller.user().filter(isGuest).isPresent();
  }
}
