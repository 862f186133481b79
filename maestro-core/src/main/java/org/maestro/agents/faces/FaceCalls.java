package org.maestro.agents.faces;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Replies;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Orders to faces, for no goal: what comes of them is nobody's concern, as people hear what is said
 * without a face, too. Agent thread only.
 */
final class FaceCalls {
  private static final Logger LOG = LoggerFactory.getLogger(FaceCalls.class);

  /** For so long a sentence may wait for those before it, and be said. */
  private static final Duration PATIENCE = Duration.ofMinutes(2);

  private final MaestroAgent agent;

  FaceCalls(MaestroAgent agent) {
    this.agent = agent;
  }

  /** What a face has no routine for it does not do. */
  void order(FaceMember face, String procedure, Map<String, Term> parameters) {
    face.feature(procedure).ifPresent(feature -> order(face.device().id(), feature, parameters));
  }

  private void order(String member, FeatureType feature, Map<String, Term> parameters) {
    Map<String, Argument> named = new TreeMap<>();
    parameters.forEach(
        (name, value) -> named.put(name, new Argument(value, Optional.empty(), Map.of())));
    agent.ask(
        agent.message(
            ACLMessage.REQUEST,
            agent.getAID(member),
            Orders.byHand(member, member, feature.name(), named, Optional.empty(), PATIENCE)),
        PATIENCE,
        reply -> {
          if (reply.getPerformative() == ACLMessage.REFUSE
              || reply.getPerformative() == ACLMessage.FAILURE) {
            LOG.debug(
                "{} does not {}: {}", member, feature.name(), Replies.reason(reply).orElse(""));
          }
        });
  }
}
