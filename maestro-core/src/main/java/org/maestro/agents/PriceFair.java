package org.maestro.agents;

import jade.core.AID;
import jade.core.behaviours.Behaviour;
import jade.lang.acl.ACLMessage;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.device.PriceResponder;
import org.maestro.agents.negotiation.AclContractNet;
import org.maestro.agents.negotiation.Contracts;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.members.MemberView;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.Step;
import org.maestro.sl.Formula;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The contract net alone, with neither bus nor goals: agents that name the prices of devices, and
 * one that asks for them. For measurements.
 */
public final class PriceFair {
  private static final Logger LOG = LoggerFactory.getLogger(PriceFair.class);

  private PriceFair() {}

  /** An agent that stands for the device; its name has to be the device's. */
  public static MaestroAgent seller(Birth birth, AgentTime time, Device device) {
    return new Seller(birth, time, device);
  }

  /** Answers calls as a generic agent does. */
  private static final class Seller extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient MemberView view = new MemberView("a seller of prices only", () -> {});
    private final transient PriceResponder prices =
        new PriceResponder(
            this, words -> Optional.of(view), PriceResponder.Access.OPEN, Optional.empty());

    Seller(Birth birth, AgentTime time, Device device) {
      super(birth, time);
      view.describedAs(device);
      view.ready(true);
    }

    @Override
    protected Optional<Behaviour> session(ACLMessage message) {
      return prices.session(message);
    }

    @Override
    protected void received(ACLMessage message) {
      refuse(
          message, ACLMessage.NOT_UNDERSTOOD, getLocalName() + " answers calls for prices only.");
    }
  }

  /** Asks all sellers, round after round. */
  public static final class Buyer extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private static final String NO_GOAL = "fair";

    private final transient Map<String, FeatureType> wanted = new LinkedHashMap<>();
    private final transient Contracts contracts = new Contracts();
    private final transient ContractNet contractNet =
        new AclContractNet(
            this, this::agentOf, contracts, (goal, sentence) -> LOG.warn("{}", sentence));

    /**
     * @param devices what they ask for is the first feature of each
     */
    public Buyer(Birth birth, AgentTime time, List<Device> devices) {
      super(birth, time);
      devices.forEach(device -> wanted.put(device.id(), device.features().get(0)));
    }

    private Optional<AID> agentOf(String member) {
      return Optional.of(getAID(member));
    }

    @Override
    protected void received(ACLMessage message) {
      refuse(message, ACLMessage.NOT_UNDERSTOOD, getLocalName() + " sells nothing.");
    }

    /**
     * One round: a call to all, the award to the first that names a price, the others rejected. Any
     * thread may call.
     *
     * @param closed is told on this agent's thread when the winner has said that it holds its part
     */
    public void round(Runnable closed) {
      Map<String, List<String>> features = new LinkedHashMap<>();
      wanted.forEach((member, feature) -> features.put(member, List.of(feature.name())));
      CallForPrices call = new CallForPrices(NO_GOAL, new Formula.And(List.of()), features);
      tell(() -> contractNet.callForPrices(call, tender -> award(tender, closed)));
    }

    private void award(ContractNet.Round tender, Runnable closed) {
      String winner =
          tender.bids().stream()
              .filter(bid -> bid.refusal().isEmpty())
              .map(Proposal::member)
              .findFirst()
              .orElseThrow(() -> new IllegalStateException("Nobody at the fair names a price."));
      FeatureType feature = Objects.requireNonNull(wanted.get(winner));
      Step step = new Step(1, winner, feature, Map.of(), 1, 1, true, Set.of());
      tender.award(Map.of(winner, List.of(step)));
      contracts.whenSettled(NO_GOAL, winner, broken -> closed.run());
    }
  }
}
