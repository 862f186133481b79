package org.maestro.agents.negotiation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.Once;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.AccessList;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.LatestAccess;

/**
 * For whom the central agent pursues its goals, and what they may have others asked for. Agent
 * thread only.
 */
public final class Clients {
  private final KnowledgeBase knowledge;
  private final Function<String, Optional<String>> requesterOf;
  private final ProtocolViolations story;
  private final Once told = new Once();
  private final LatestAccess access = new LatestAccess();

  /**
   * @param requesterOf who asked for a goal, by its id
   * @param story is told what was refused
   */
  public Clients(
      KnowledgeBase knowledge,
      Function<String, Optional<String>> requesterOf,
      ProtocolViolations story) {
    this.knowledge = knowledge;
    this.requesterOf = requesterOf;
    this.story = story;
  }

  /** For whom, where that matters. */
  public Optional<String> of(String goalId) {
    return access.of(knowledge.home()).isOpen() ? Optional.empty() : requesterOf.apply(goalId);
  }

  /** Which of the member's features are not to be used for the goal, each with the reason. */
  List<Refused> refused(String goalId, String member, List<String> features) {
    Home home = knowledge.home();
    AccessList list = access.of(home);
    Optional<Device> device = Optional.ofNullable(home.devices().get(member));
    Optional<Caller> client = requesterOf.apply(goalId).map(Caller::parse);
    List<Refused> refused = new ArrayList<>();
    if (!list.isOpen() && device.isPresent() && client.isPresent()) {
      for (String feature : features) {
        list.objection(client.get().names(), device.get(), feature)
            .ifPresent(reason -> refused.add(new Refused(feature, reason)));
      }
    }
    refused.forEach(one -> tell(goalId, one.reason()));
    return refused;
  }

  record Refused(String feature, String reason) {}

  private void tell(String goalId, String reason) {
    if (told.isNew(goalId + " " + reason)) {
      story.noted(goalId, reason);
    }
  }
}
