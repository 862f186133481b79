package org.maestro.console.states;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.console.documents.JsonMembers;

/** The states of a platform's parts as JSON. */
final class StatesDocument {
  private StatesDocument() {}

  /**
   * @param shownAfter so long after it is known it is told at the latest
   */
  static JsonNode of(Observed observed, Duration shownAfter) {
    Derivation derivation = new Derivation(observed);
    HeartbeatSettings timing = observed.timing();
    JsonMembers document = JsonMembers.empty();
    new JsonMembers(document.node().putObject("timing"))
        .number("sign_every_s", Seconds.in(timing.period()))
        .number("doubtful_after_s", Seconds.in(timing.suspectedAfter()))
        .number("lost_after_s", Seconds.in(timing.lostAfter()))
        .number(
            "shown_within_s",
            Seconds.in(timing.suspectedAfter().plus(timing.period()).plus(shownAfter)));
    ArrayNode parts = document.node().putArray("parts");
    derive(JsonMembers.in(parts).text("part", "bus"), derivation.bus());
    derive(JsonMembers.in(parts).text("part", "journal"), derivation.journal());
    ArrayNode containers = document.node().putArray("containers");
    observed.gone().forEach(one -> derive(container(containers, one), derivation.gone()));
    observed
        .containers()
        .forEach(one -> derive(container(containers, one), derivation.container(one)));
    ArrayNode agents = document.node().putArray("agents");
    ArrayNode members = document.node().putArray("members");
    for (Observed.Agent agent : observed.agents()) {
      derive(
          JsonMembers.in(agents).text("agent", agent.name()).text("container", agent.container()),
          derivation.agent(agent));
      for (String member : agent.members()) {
        derive(
            JsonMembers.in(members).text("member", member).text("agent", agent.name()),
            derivation.member(member, agent));
      }
    }
    return document.node();
  }

  private static JsonMembers container(ArrayNode containers, Observed.Container container) {
    return JsonMembers.in(containers)
        .text("container", container.name())
        .text("process", container.process())
        .number("silence_s", Seconds.in(container.silence()))
        .words("agents", container.agents());
  }

  private static void derive(JsonMembers row, Derived derived) {
    row.text("state", Derivation.inWords(derived)).text("why", derived.why());
  }
}
