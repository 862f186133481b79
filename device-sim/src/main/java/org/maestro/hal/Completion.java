package org.maestro.hal;

/**
 * The callback for the end of a command to a driver; exactly one of both is told, unless the device
 * dies or is stopped. Clock thread.
 */
public interface Completion {

  void done();

  /**
   * @param reason one sentence for people
   */
  void failed(String reason);
}
