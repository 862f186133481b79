package org.maestro.platform.guard;

import jade.core.AID;
import jade.core.Agent;
import jade.core.GenericCommand;
import jade.core.HorizontalCommand;
import jade.core.IMTPException;
import jade.core.Node;
import jade.core.Service;
import jade.core.ServiceException;
import jade.core.VerticalCommand;
import jade.core.mobility.AgentMobilityHelper;
import jade.core.mobility.AgentMobilityService;
import jade.core.mobility.AgentMobilitySlice;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/**
 * JADE's service for agents that move, without code that moves: an agent arrives only if its
 * classes are here already, and nobody is given classes. JADE's own one fetches what it does not
 * know from where the agent comes from, and runs it. JADE makes it by its class name.
 */
public final class HomeMobilityService extends AgentMobilityService {
  private final Refusals refusals = new Refusals();
  private final Service.Slice guarded = new Guarded();

  @Override
  public Service.Slice getLocalSlice() {
    return guarded;
  }

  private Service.Slice unguarded() {
    return super.getLocalSlice();
  }

  /** The slice that does what other containers ask for, as far as it is done here. */
  private final class Guarded implements Service.Slice {
    private static final long serialVersionUID = 1L;

    @Override
    public Service getService() {
      return HomeMobilityService.this;
    }

    @Override
    public Node getNode() throws ServiceException {
      return unguarded().getNode();
    }

    @Override
    public @Nullable VerticalCommand serve(HorizontalCommand command) {
      return switch (command.getName()) {
        case AgentMobilitySlice.H_CREATEAGENT -> arrive(command);
        case AgentMobilitySlice.H_FETCHCLASSFILE -> {
          command.setReturnValue(
              new ClassNotFoundException("This container gives nobody its classes."));
          yield null;
        }
        default -> unguarded().serve(command);
      };
    }
  }

  /** As JADE does it, but for the way in which the agent is read. */
  private @Nullable VerticalCommand arrive(HorizontalCommand command) {
    try {
      Agent read = Arrival.of((byte[]) command.getParam(1));
      GenericCommand moved =
          new GenericCommand(AgentMobilityHelper.INFORM_MOVED, AgentMobilityService.NAME, null);
      moved.addParam(command.getParam(0));
      moved.addParam(read);
      for (int rest = 2; rest < command.getParams().length; rest++) {
        moved.addParam(command.getParam(rest));
      }
      return moved;
    } catch (ClassNotFoundException foreign) {
      return refuse(command, "it is of a class that is not here, " + foreign.getMessage());
    } catch (IOException | RuntimeException none) {
      return refuse(command, "it is none of those that may come (" + none.getMessage() + ")");
    }
  }

  private @Nullable VerticalCommand refuse(HorizontalCommand command, String reason) {
    String name = command.getParam(0) instanceof AID agent ? agent.getName() : "without a name";
    String sentence = "An agent that moves here, %s, was refused: %s.".formatted(name, reason);
    refusals.log(sentence);
    command.setReturnValue(new IMTPException(sentence));
    return null;
  }
}
