package org.maestro.hal;

/** A relay, a plug or an appliance that is on or off. */
public interface Switch {

  void set(boolean on, Completion completion);

  boolean isOn();
}
