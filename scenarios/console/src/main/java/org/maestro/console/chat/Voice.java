package org.maestro.console.chat;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.RoomHearing;

/** The voice in which is answered: that of the home, or that of one of its rooms' agents (A88). */
final class Voice {
  private Voice() {}

  /** The persona of a room agent, if it has one of its own. */
  static Optional<String> persona(Home home, String agent) {
    return Optional.ofNullable(home.groups().get(agent))
        .flatMap(Group::hearing)
        .flatMap(RoomHearing::persona);
  }

  /** A listener that is told the same, with who speaks before it. */
  static Consumer<ChatEvent> of(Optional<String> persona, Consumer<ChatEvent> listener) {
    return persona
        .<Consumer<ChatEvent>>map(name -> event -> listener.accept(spoken(name + ": ", event)))
        .orElse(listener);
  }

  private static ChatEvent spoken(String before, ChatEvent event) {
    String text = before + event.text();
    if (event instanceof ChatEvent.Understood understood) {
      return new ChatEvent.Understood(understood.goal(), text);
    } else if (event instanceof ChatEvent.Told told) {
      return new ChatEvent.Told(told.goal(), text);
    } else if (event instanceof ChatEvent.Asked asked) {
      return new ChatEvent.Asked(text, asked.choices());
    } else if (event instanceof ChatEvent.Ended ended) {
      return new ChatEvent.Ended(ended.goal(), ended.reached(), text);
    }
    return new ChatEvent.Misunderstood(text, ((ChatEvent.Misunderstood) event).near());
  }
}
