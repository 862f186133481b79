package org.maestro.hal;

/**
 * How a command to a driver ended; exactly one of both is told, unless the device dies or is
 * stopped. Clock thread.
 */
public interface Completion {

  void done();

  /**
   * @param reason one sentence for people
   */
  void failed(String reason);
}
