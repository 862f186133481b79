package org.maestro.hal;

/** A relay or plug that is on or off. */
public interface Switch {

  void set(boolean on, Completion completion);

  boolean isOn();
}
