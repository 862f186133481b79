package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Agents that hear what is said in rooms, as a home's file describes them. */
class RoomAgentsTest {
  private static final String BOB = ShippedHomes.text("bob.ttl");
  private static final String AGENT =
      """

      home:talk a maestro:Topic ; rdfs:label "talk" ; maestro:includes home:saying .
      home:saying a maestro:Construction ; maestro:says "say hello"@en ; maestro:means "(perform (:script greet))" .
      home:ears a maestro:RoomAgent ; rdfs:label "the ears of A" ; maestro:hears home:room-a ; maestro:persona "Room A" ;
        maestro:memberWhen "(inside ?member zone-a)" ; maestro:understands home:talk .
      """;

  private static Home load(String text) {
    return new HomeLoader().load(text, "bob.ttl");
  }

  @Test
  void anAgentHearsInItsRoomsAndNeedsNoGoal() {
    Home home = load(BOB + AGENT);

    assertThat(home.listener("room-a").map(Group::id)).contains("ears");
    assertThat(home.listener("room-b")).isEmpty();
    assertThat(home.groups().get("ears").hearing())
        .contains(new RoomHearing(Set.of("room-a"), Set.of("talk"), Optional.of("Room A")));
    assertThat(home.wording().about(Set.of("talk")).constructions())
        .extracting(one -> one.name())
        .containsExactly("saying");
  }

  @Test
  void whatIsWrongWithOneIsToldWithItsLine() {
    assertThatThrownBy(() -> load(BOB + AGENT.replace("maestro:hears home:room-a ; ", "")))
        .hasMessageContaining("hears")
        .hasMessageContaining("is not stated; name the room in which it hears what is said");
    assertThatThrownBy(() -> load(BOB + AGENT.replace("hears home:room-a", "hears home:lamp-a1")))
        .hasMessageContaining("is no room; name a maestro:Room of the home");
    assertThatThrownBy(
            () -> load(BOB + AGENT.replace("understands home:talk", "understands home:tlak")))
        .hasMessageContaining("names tlak, which is neither a topic nor a construction")
        .hasMessageContaining("write talk, if that is meant");
    assertThatThrownBy(
            () ->
                load(
                    BOB
                        + AGENT
                        + "home:more a maestro:RoomAgent ; maestro:hears home:room-a ;"
                        + " rdfs:label \"more ears\" ."))
        .hasMessageContaining("names room-a, in which ears hears what is said");
  }
}
