package org.maestro.rats.link;

/**
 * A call under way.
 *
 * @param ending has it cancelled; any thread
 */
record Handle(String callId, Runnable ending) implements RatsLink.CallHandle {
  @Override
  public void cancel() {
    ending.run();
  }
}
