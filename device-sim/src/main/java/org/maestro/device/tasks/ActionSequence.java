package org.maestro.device.tasks;

import java.util.List;
import org.maestro.hal.Completion;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A task's local plan (Three-layered architecture, 3.2; M29): atomic actions of the device, one
 * after the other. It stays private; only the share done is told. It goes no further once the call
 * has ended. Clock thread only.
 */
final class ActionSequence {

  private static final Logger LOG = LoggerFactory.getLogger(ActionSequence.class);

  private final String device;
  private final Execution execution;
  private final List<Action> actions;
  private final Runnable after;

  /**
   * @param after what to do when all are done
   */
  ActionSequence(String device, Execution execution, List<Action> actions, Runnable after) {
    this.device = device;
    this.execution = execution;
    this.actions = List.copyOf(actions);
    this.after = after;
  }

  void run() {
    run(0);
  }

  private void run(int index) {
    if (execution.ended()) {
      return;
    }
    if (index == actions.size()) {
      after.run();
      return;
    }
    if (index > 0) {
      execution.progress((double) index / actions.size());
    }
    Action action = actions.get(index);
    LOG.debug("{} {} ({} of {})", device, action.name(), index + 1, actions.size());
    action
        .command()
        .start(
            new Completion() {
              @Override
              public void done() {
                run(index + 1);
              }

              @Override
              public void failed(String reason) {
                execution.fail(action.failure().of(reason));
              }
            });
  }

  /**
   * One atomic action.
   *
   * @param failure the answer to the caller when it fails
   */
  record Action(String name, Command command, Failure failure) {
    Action(String name, Command command) {
      this(name, command, FeatureContext::broken);
    }
  }

  interface Command {
    void start(Completion completion);
  }

  interface Failure {
    RatsError of(String reason);
  }
}
