package org.maestro.agents.runtime;

import jade.core.Agent;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.FIPAManagementVocabulary;
import jade.domain.FIPAAgentManagement.Property;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.agents.content.Words;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;

/**
 * An agent's entry in the directory facilitator (Three-layered architecture, 3.3.1; M65): a service
 * for each feature that its members have now, with the feature's name as type, so that a stranger
 * finds who can do it; and how to ask for it, in the service's properties.
 */
public final class YellowPages {

  private YellowPages() {}

  /**
   * The message that makes the entry so; empty when nothing is to be said.
   *
   * @param offering what the members are that can be used now, by id
   * @param registered whether there is an entry already
   */
  public static Optional<ACLMessage> request(
      Agent agent, Map<String, Device> offering, boolean registered) {
    if (offering.isEmpty() && !registered) {
      return Optional.empty();
    }
    String action =
        offering.isEmpty()
            ? FIPAManagementVocabulary.DEREGISTER
            : registered ? FIPAManagementVocabulary.MODIFY : FIPAManagementVocabulary.REGISTER;
    return Optional.of(
        DFService.createRequestMessage(
            agent, agent.getDefaultDF(), action, entry(agent, offering), null));
  }

  private static DFAgentDescription entry(Agent agent, Map<String, Device> offering) {
    DFAgentDescription entry = new DFAgentDescription();
    entry.setName(agent.getAID());
    entry.addLanguages(Words.LANGUAGE);
    entry.addOntologies(Words.ONTOLOGY);
    entry.addProtocols(FIPANames.InteractionProtocol.FIPA_REQUEST);
    offering.forEach(
        (member, device) ->
            device.features().forEach(f -> entry.addServices(service(agent, member, f))));
    return entry;
  }

  private static ServiceDescription service(Agent agent, String member, FeatureType feature) {
    ServiceDescription service = new ServiceDescription();
    service.setType(feature.name());
    service.setName(member + "/" + feature.name());
    service.addLanguages(Words.LANGUAGE);
    service.addOntologies(Words.ONTOLOGY);
    service.addProtocols(FIPANames.InteractionProtocol.FIPA_REQUEST);
    service.addProperties(new Property("member", member));
    service.addProperties(new Property("request", request(agent, member, feature)));
    service.addProperties(new Property("answers", parameters(feature.outputs())));
    return service;
  }

  /** Such as {@code (perform (:feature find) (:parameters (:object Thing) (:zone Zone)))}. */
  private static String request(Agent agent, String member, FeatureType feature) {
    String which = member.equals(agent.getLocalName()) ? "" : " (:member " + member + ")";
    List<Parameter> inputs =
        Stream.concat(feature.inputs().stream(), feature.binds().stream())
            .filter(input -> !input.optional())
            .toList();
    return "(perform%s (:feature %s) (:parameters%s))"
        .formatted(which, feature.name(), inputs.isEmpty() ? "" : " " + parameters(inputs));
  }

  private static String parameters(List<Parameter> parameters) {
    return parameters.stream()
        .map(p -> "(:" + p.name() + " " + String.join("|", p.types()) + ")")
        .collect(Collectors.joining(" "));
  }
}
