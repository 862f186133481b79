package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.coordination.api.Requester;
import org.maestro.dialogue.Utterance;

/** Something that was said, and who tells it. */
record Said(ACLMessage message, Words words, Caller caller, Utterance utterance) {
  String person() {
    return utterance.person();
  }

  /** In whose name goals are stated by it. */
  String requester() {
    return new Requester(caller.toString(), Optional.of(person())).toString();
  }
}
