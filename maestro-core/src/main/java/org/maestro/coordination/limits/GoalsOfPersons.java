package org.maestro.coordination.limits;

import java.util.Optional;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Requester;
import org.maestro.coordination.api.Story;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.GoalObjections;
import org.maestro.ontology.permission.Restrictions;

/** What holds for goals by who asks for them (ADE, 5; A85). The coordinator's thread only. */
public final class GoalsOfPersons {
  private final Ports ports;

  public GoalsOfPersons(Ports ports) {
    this.ports = ports;
  }

  /** Why nothing is to be done for the goal, in a sentence; empty when it may be begun. */
  public Optional<String> objection(GoalRequest request) {
    Home home = ports.knowledge().home();
    return isAnythingSaid(home)
        ? new GoalObjections(home, ports.knowledge().snapshot())
            .of(request.goal(), person(request))
            .map(new ObjectionSentences(home)::of)
        : Optional.empty();
  }

  /**
   * The world in which the goal is pursued.
   *
   * @param story is told to what its plans keep
   */
  public Ports world(GoalRequest request, Story story) {
    if (!isAnythingSaid(ports.knowledge().home())) {
      return ports;
    }
    Optional<String> person = person(request);
    return ports.with(
        new HomeOfPerson(ports.knowledge(), person),
        new BidsForPerson(ports.with(story), person),
        new OrdersForPerson(ports, person));
  }

  private static boolean isAnythingSaid(Home home) {
    return !Restrictions.of(home).areNone();
  }

  private static Optional<String> person(GoalRequest request) {
    return Requester.parse(request.requester()).person();
  }
}
