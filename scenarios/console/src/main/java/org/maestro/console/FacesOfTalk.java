package org.maestro.console;

import java.util.List;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.faces.Faces;
import org.maestro.console.chat.ChatEvent;
import org.maestro.dialogue.Utterance;
import org.maestro.knowledge.api.KnowledgeBase;

/**
 * The answers of the chat at the faces where the person is, besides, in the name of the room that
 * answers. Any thread may call it.
 */
final class FacesOfTalk {
  private final DeskAgent desk;
  private final Faces faces;

  FacesOfTalk(DeskAgent desk, KnowledgeBase knowledge) {
    this.desk = desk;
    this.faces = new Faces(desk, desk.getLocalName(), knowledge);
  }

  void show(Utterance utterance, ChatEvent event) {
    desk.tell(() -> shown(utterance, event));
  }

  private void shown(Utterance utterance, ChatEvent event) {
    if (event instanceof ChatEvent.Understood understood) {
      faces.answered(utterance, new SaidReply.TakenOn("", List.of(understood.goal())));
      faces.answered(utterance, new SaidReply.Replied("", understood.text()));
    } else if (event instanceof ChatEvent.Told told) {
      faces.answered(utterance, new SaidReply.Replied("", told.text()));
    } else if (event instanceof ChatEvent.Asked asked) {
      faces.answered(utterance, new SaidReply.Asked(asked.text()));
    } else if (event instanceof ChatEvent.Ended ended) {
      faces.ended(utterance, ended.reached(), ended.text());
    } else if (event instanceof ChatEvent.Misunderstood wrong) {
      faces.answered(utterance, new SaidReply.Refused(wrong.text()));
    }
  }
}
